#pragma once

// Shards of maps: boxes or columns, and what is to be made of all of them together.

#include <span>
#include <string>

#include "geom/map/column_grid.h"
#include "geom/map/make_map.h"
#include "sharding.h"

namespace cli {

// What geom::make_map() takes besides the boxes.
struct MapMaking {
  geom::Frame frame;
  std::string history;
  geom::MakeMapOptions options;
};

void write_shard(const Sharding& sharding, const std::string& file, const geom::BoxTable& table,
                 const MapMaking& making);
void write_shard(const Sharding& sharding, const std::string& file, const geom::ColumnGrid& columns,
                 const geom::ColumnSpec& spec, const MapMaking& making);

// Whether shards of this kind make a map.
bool is_map_shard(const ShardFile& shard);

// The map of all shards, in their order; throws geom::InputError where they do not fit.
geom::MadeMap join_map(std::span<const ShardFile> shards);

}  // namespace cli
