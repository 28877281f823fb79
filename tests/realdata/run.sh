#!/usr/bin/env bash
# run.sh BIN_DIR: the chain on the real tables in the folder that SKYWAY_REALDATA names.
set -euo pipefail
if [ -z "${SKYWAY_REALDATA:-}" ]; then
  echo "skipped: SKYWAY_REALDATA is not set"
  exit 77
fi
export PATH="$1:$PATH"
tables=$SKYWAY_REALDATA/colliders
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

boxes() { skyway-import -q "$tables/$1.csv" | skyway-map to-csv - | sort; }
boxes udacity_colliders > all
[ "$(wc -l < all)" -eq 3846 ]
for same in seed_obstacle-data abhiojha8_crlf irvingvasquez_bare-latlon; do
  boxes "$same" | cmp - all
done
# jwdunn1 leaves props out and hangs nothing: compare before sealing.
skyway-import -q --seal 0 "$tables/udacity_colliders.csv" | skyway-map to-csv - | sort > unsealed
skyway-import -q --seal 0 "$tables/jwdunn1.csv" | skyway-map to-csv - | sort > part
[ "$(wc -l < part)" -eq 3214 ]
[ "$(comm -23 part unsealed | wc -l)" -eq 0 ]
[ "$(boxes yuluis_short_3line-header | wc -l)" -eq 794 ]

skyway-import -q "$tables/udacity_colliders.csv" -o map
cat > queries <<'JSON'
{"id":"street-local-0","from":[-1.756683,68.508093,10.179412],"to":[30.970009,36.382374,21.711315]}
{"id":"street-local-1","from":[299.423106,140.073490,6.333305],"to":[261.914737,118.502122,23.546779]}
{"id":"street-local-2","from":[-14.931657,-331.811228,28.565901],"to":[-0.595477,-371.679742,6.308936]}
JSON
skyway-plan map --queries queries --vehicle box:1,1,1 | skyway-traj map --vmax 8 --amax 6 | skyway-check map -o reports
[ "$(grep -c '"ok":true' reports)" -eq 3 ]
for text in "$SKYWAY_REALDATA"/blockmaps/*.txt; do
  case $text in *startgoal*) continue ;; esac
  skyway-import "$text" | skyway-map info - > /dev/null
done
for text in "$SKYWAY_REALDATA"/blockmaps/*.json "$SKYWAY_REALDATA"/voxels/*.3dmap; do
  skyway-import "$text" | skyway-map info - > /dev/null
done
# The default RRT solves every course: map, vehicle, margin, start and goal.
while read -r course vehicle margin from to; do
  skyway-import -q "$SKYWAY_REALDATA/blockmaps/$course" -o course
  skyway-plan course --vehicle "$vehicle" --margin "$margin" --from="$from" --to="$to" --method rrt | skyway-check -q course > /dev/null
done <<'TABLE'
double_pillar.json crazyflie 0.05 1.1,-4,1 1.1,4,1
grid_forest.json crazyflie 0.05 0.25,1.25,1 2.25,5.25,2
ece276b_notu97_maze.txt crazyflie 0.1 0,0,1 12,12,5
ece276b_notu97_single_cube.txt crazyflie 0.1 2.3,2.3,1.3 7,7,5.5
ece276b_notu97_window.txt tello 0.1 0.3,-4.7,0.3 6,18,3
upenn_akhibhat_map0.txt tello 0.1 2,2.5,1 19.5,2.5,1
upenn_akhibhat_map1.txt tello 0.1 0.3,-4.7,0.3 6,18,3
wpi_pear_p2b_map1.txt tello 0.05 0,0,0.5 -0.59,6.81,0.5
TABLE
count() { skyway-map info "$1" | sed -n 's/^boxes: //p'; }
skyway-import -q "$SKYWAY_REALDATA/clouds/octomap/geb079.bt" -o tree
[ "$(count tree)" -eq 143729 ]  # what octomap-tools' bt2vrml counts
skyway-import -q "$SKYWAY_REALDATA/voxels/Complex.3dmap" -o voxels
[ "$(count voxels)" -eq "$(grep -c '^[0-9]' "$SKYWAY_REALDATA/voxels/Complex.3dmap")" ]
traj=$SKYWAY_REALDATA/traj
records() { skyway-import-trajectory -q "$@" | grep -o "\"type\":\"$kind\"" | wc -l; }
kind=trajectory
[ "$(records "$traj/crazyswarm2/data_figure8.csv")" -eq 1 ]  # a comma ends its lines
[ "$(records "$traj/crazyswarm2/multi_trajectory_traj1.csv")" -eq 1 ]
if skyway-import-trajectory --gap 1e-6 "$traj/crazyswarm2/multi_trajectory_traj1.csv" 2> why; then exit 1; fi
grep -q 'position steps by 5.*e-05 m where segment 1 begins, at t = 1.58689 s' why
skyway-import-trajectory -q "$traj/crazyswarm2/data_figure8.csv" -o figure8
printf 'min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n2,2,0,3,3,1,\n' > box.csv
skyway-import box.csv -q --bounds=-3,-3,-1,3,3,2 -o room
skyway-check room figure8 --vehicle crazyflie | grep -q '"ok":true'
skyway-check room "$traj/crazyswarm2/data_figure8.csv" --file-format auto --vehicle crazyflie | grep -q '"ok":true'
kind=path
[ "$(records "$traj/uav_trajectories/waypoints1.csv")" -eq 1 ]
[ "$(records "$traj/dronekit_mpmission.txt" --origin -35.363262,149.165237,584)" -eq 1 ]
for mission in "$traj"/mavsdk_plans/*; do
  [ "$(records "$mission" --origin 47.3977507,8.5456075,488.93 --ground 0)" -eq 1 ]
done
if command -v skyway-footprints > /dev/null; then
  city=$SKYWAY_REALDATA/city
  if skyway-footprints "$city/osm/Helsinki.osm.pbf" -o none 2> why; then exit 1; fi
  grep -q "324 x electrified=contact_line" why
  grep -q "2979 possible obstacles .* found none for 341 of 632" why
  [ "$(wc -c < why)" -lt 1600 ]
  skyway-footprints -q --allow-skipped --default-height 10 "$city/osm/Helsinki.osm.pbf" --stats stats -o helsinki
  grep -q '"skipped: part of an outline whose nodes are not in the file": 54' stats
  grep -q '"skipped: historic=memorial with a height": 1' stats  # a statue of 11.7 m, way 59148128
  grep -q '"skipped: historic=monument with a height": 1' stats  # node 5240070521
  grep -q '"footprints": 632' stats  # the 572 building areas of osmium's own export, 54 cut outlines, 6 torn multipolygons
  if skyway-footprints -q --default-height 10 "$city/geojson/Helsinki_buildings_from_osm.geojson" -o none 2> why; then exit 1; fi
  grep -q "1 x tower, mast or the like without a height" why
  skyway-footprints -q --allow-skipped --default-height 10 "$city/geojson/Helsinki_buildings_from_osm.geojson" --stats stats -o helsinki
  grep -q '"footprints": 575' stats
  skyway-footprints -q "$city/cityjson/cjio_delft.json" -o delft
  for refused in spec_invalid3 spec_twocube; do
    if skyway-footprints "$city/cityjson/$refused.json" -o none 2> why; then exit 1; fi
    grep -q 'expected CityJSON version\|expected each key once' why
  done
fi
mission=$SKYWAY_REALDATA/missions/dji_pilot2_seed.kmz  # by DJI Pilot 2, which says 121.03 m of its leg (on a sphere)
skyway-import-trajectory -q "$mission" --origin 49.715,-101.148,0 --ground 0 > imported
grep -q '"length":131.0[0-9]*,"points":\[\[[-0-9.]*,[-0-9.]*,20\],\[[-0-9.]*,[-0-9.]*,10\],\[[-0-9.]*,[-0-9.]*,10\]\]' imported
if command -v skyway-cloud > /dev/null; then
  clouds=$SKYWAY_REALDATA/clouds
  points() { skyway-cloud -q "$clouds/$1" --stats stats -o cloud; sed -n 's/^  "points": \([0-9]*\),/\1/p' stats; }
  [ "$(points las/1.2-with-color.las)" -eq 1065 ]
  [ "$(points las/autzen_trim_7.las)" -eq 110000 ]
  [ "$(points laz/autzen_trim.laz)" -eq 110000 ]
  for laz in simple point-color point-time-1.4 1.2-with-color.copc simple_with_page.copc; do
    [ "$(points "laz/$laz.laz")" -eq 1065 ]
  done
  # LAZ files with a twin in LAS or in another point format: the same boxes.
  boxes_of() { skyway-cloud -q "$clouds/$1" --cell 0.5 --step 0.05 | skyway-map to-csv - | sort; }
  boxes_of laz/simple.laz | cmp - <(boxes_of las/1.2-with-color.las)
  boxes_of laz/point-time-1.4.laz | cmp - <(boxes_of laz/point-color.laz)
  boxes_of laz/autzen_trim.laz | cmp - <(boxes_of las/autzen_trim_7.las)
  [ "$(points pcd/samp11-utm.pcd)" -eq 38010 ]
  [ "$(points pcd/pdal_autzen-utm.pcd)" -eq 1065 ]
  [ "$(points ply/pdal_simple_binary.ply)" -eq 3 ]
  if skyway-cloud "$clouds/las/no-points.las" -o none 2> why; then exit 1; fi
  grep -q "not metres on the ground" why
  skyway-cloud -q "$clouds/las/autzen_trim_7.las" -o autzen  # in feet
  skyway-map info autzen | grep -q "bounds_max_m: .194213.0,258927.0,159.0."
  if skyway-cloud "$clouds/ply/pdal_mesh.ply" -o none 2> why; then exit 1; fi
  grep -q "surface of a mesh" why
fi
# A PX4 log of a vehicle that never knew where it was.
if [ -f "$SKYWAY_REALDATA/flights/px4_small.ulg" ]; then
  if skyway-import-flight "$SKYWAY_REALDATA/flights/px4_small.ulg" 2> why; then exit 1; fi
  grep -q "found none in 636 rows of vehicle_local_position" why
  grep -q "1 dropout of 0.03 s" why
fi
echo "real data agree"
# Worlds: PX4's walls, jps3d's course, and San Francisco there and back.
if [ -d "$SKYWAY_REALDATA/meshes" ]; then
  skyway-import -q "$SKYWAY_REALDATA/meshes/walls.sdf" -o walls
  [ "$(count walls)" -eq 4 ]
  skyway-import -q "$SKYWAY_REALDATA/voxels/jps3d_simple3d.yaml" -o course
  [ "$(count course)" -eq 96 ]
  for world in map walls; do
    skyway-map to-sdf "$world" -o there.sdf
    skyway-import -q there.sdf -o there
    skyway-map to-sdf there -o back.sdf
    skyway-import -q back.sdf -o back
    [ "$(count there)" -eq "$(count "$world")" ]
    skyway-map diff there back > /dev/null
  done
fi
