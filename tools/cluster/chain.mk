# The chain of a folder's chain.conf on one machine: make -j -f …/tools/cluster/chain.mk FOLDER=…
# A shard that is done already costs nothing when it is made again, and is touched.

FOLDER ?= .
here := $(dir $(realpath $(lastword $(MAKEFILE_LIST))))
include $(FOLDER)/chain.conf
step = $(here)step.sh $(FOLDER)
number = $(subst ",,$(1))
shards = $(foreach k,$(shell seq $(call number,$($(2)))),$(FOLDER)/shards/$(1).$(k))

map := $(FOLDER)/city.boxmap
lattice := $(FOLDER)/city.lattice
roadmap := $(FOLDER)/city.roadmap
paths := $(FOLDER)/paths.jsonl
trajectories := $(FOLDER)/trajectories.jsonl
reports := $(FOLDER)/reports.jsonl

.PHONY: all
.DELETE_ON_ERROR:
all: $(reports)
	$(step) summary

$(map):
	$(step) map
$(FOLDER)/shards/lattice.%: $(map)
	$(step) lattice $* && touch $@
$(FOLDER)/shards/roadmap.%: $(map)
	$(step) roadmap $* && touch $@
$(FOLDER)/shards/paths.%: $(lattice) $(roadmap)
	$(step) paths $* && touch $@
$(FOLDER)/shards/trajectories.%: $(paths)
	$(step) trajectories $* && touch $@
$(FOLDER)/shards/reports.%: $(trajectories)
	$(step) reports $* && touch $@

$(lattice): $(call shards,lattice,LATTICE_SHARDS)
	$(step) join-lattice
$(roadmap): $(call shards,roadmap,ROADMAP_SHARDS)
	$(step) join-roadmap
$(paths): $(call shards,paths,PATH_SHARDS)
	$(step) join-paths
$(trajectories): $(call shards,trajectories,TRAJECTORY_SHARDS)
	$(step) join-trajectories
$(reports): $(call shards,reports,REPORT_SHARDS)
	$(step) join-reports
