# meshes.sh DATA_DIR: in an empty folder, a mesh of a map alone and one of everything, as .ply and .glb.
# To be sourced, with the tools on the PATH.
skyway-import -q --bounds 0,0,0,80,60,60 "$1/village.csv" -o map
skyway-plan map --from 5,30,5 --to 70,10,5 --vehicle box:1,1,1 --method rrt --tree tree.jsonl -o path
skyway-traj map path --vmax 8 --amax 6 --corridor-file corridor.jsonl -o trajectory
for format in ply gltf; do
  ending=${format/gltf/glb}
  skyway-map to-$format map -o map.$ending
  skyway-map to-$format map tree.jsonl path trajectory corridor.jsonl -o all.$ending
done
