# Debian packages by CPack, one a component: `cpack -G DEB` in a build made with the prefix /usr.

# component, package, section, description: a summary, then the text.
function(skyway_package component package section description)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${description}" PARENT_SCOPE)
  # What Debian's policy wants of every package.
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright DESTINATION ${folder}
          COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${folder} COMPONENT ${component})
endfunction()

file(STRINGS packaging/changelog newest LIMIT_COUNT 1)
if(NOT newest MATCHES "^skyway \\(${PROJECT_VERSION}\\) ")
  message(FATAL_ERROR "packaging/changelog begins with \"${newest}\", expected ${PROJECT_VERSION}")
endif()
file(STRINGS packaging/changelog signature REGEX "^ -- .*>" LIMIT_COUNT 1)
# Whoever builds packages for others says who they are, as to Debian's own tools. The changelog's address is of a domain
# that no one can have (RFC 2606), so that no stranger is written to.
if(DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  string(REGEX REPLACE "^ -- (.*>)  .*" "\\1" CPACK_PACKAGE_CONTACT "${signature}")
endif()
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/packaging/changelog
                OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)

set(CPACK_PACKAGE_NAME skyway)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_COMPONENTS_ALL tools development)

# What programs load when they need it (geom/base/loaded_library.h), which nothing finds by itself.
set(skyway_loaded coinor-libipopt1v5 libembree3-3 libexpat1 liblzf1)
if(SKYWAY_MESH)
  list(APPEND skyway_loaded libassimp5)
endif()
list(JOIN skyway_loaded ", " skyway_loaded)

skyway_package(tools skyway science "offline map and path toolkit for drones in cities
City tables and text maps become box maps, box maps become lattices and
roadmaps, those give paths, and paths become minimum-snap trajectories that
are proved free of collision and inside the vehicle's limits, and are written
in the form that the drone reads. Every step is a command-line tool.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${skyway_loaded}")
# Loaded for the few options that read or write files of GIS programs.
set(skyway_loaded_if_there libgdal32)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "${skyway_loaded_if_there}, skyway-footprints, skyway-cloud, skyway-mesh, python3-skyway, make, slurm-client")

skyway_package(development libskyway-dev libdevel "libraries of the Skyway toolkit
Headers and static libraries of what the tools are made of: box maps and exact
collision queries, path planning, trajectories and their proof. A CMake package
is included: find_package(skyway), then link skyway::plan or skyway::traj.")
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  libeigen3-dev libfmt-dev nlohmann-json3-dev libsimdjson-dev liboctomap-dev libgeographiclib-dev libgmp-dev
  libmpfr-dev libssl-dev zlib1g-dev libdeflate-dev coinor-libipopt1v5 libembree3-3 libexpat1 liblzf1)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "libpng-dev, libgdal-dev, libbz2-dev, libexpat1-dev, liblz4-dev, libproj25, pkg-config, libassimp5, libdraco-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)

# Each of the three has a part of the Python module, too.
set(skyway_part_depends "")
if(SKYWAY_PYTHON)
  set(skyway_part_depends ", python3")
endif()

if(SKYWAY_FOOTPRINTS)
  list(APPEND CPACK_COMPONENTS_ALL footprints)
  skyway_package(footprints skyway-footprints science "building footprints to Skyway box maps
Reads GeoJSON, GeoPackage, Shapefile, FlatGeobuf, OpenStreetMap, CityJSON and
height models, and makes box maps of them for the tools of the package skyway.")
  set(CPACK_DEBIAN_FOOTPRINTS_PACKAGE_RECOMMENDS skyway)
  set(CPACK_DEBIAN_FOOTPRINTS_PACKAGE_DEPENDS "libexpat1, libgdal32, libproj25${skyway_part_depends}")
endif()

if(SKYWAY_CLOUD)
  list(APPEND CPACK_COMPONENTS_ALL cloud)
  skyway_package(cloud skyway-cloud science "point clouds to Skyway box maps
Reads PCD, PLY, LAS, LAZ and XYZ point clouds, and makes box maps of them for
the tools of the package skyway.")
  set(CPACK_DEBIAN_CLOUD_PACKAGE_RECOMMENDS skyway)
  set(skyway_loaded_by_cloud libproj25)
  set(CPACK_DEBIAN_CLOUD_PACKAGE_DEPENDS "liblzf1, ${skyway_loaded_by_cloud}${skyway_part_depends}")
endif()

if(SKYWAY_MESH)
  list(APPEND CPACK_COMPONENTS_ALL mesh)
  skyway_package(mesh skyway-mesh science "models of triangles to Skyway box maps
Reads OBJ, PLY, STL, glTF, COLLADA, 3DS and 3D Tiles, and makes box maps of
them for the tools of the package skyway.")
  set(CPACK_DEBIAN_MESH_PACKAGE_RECOMMENDS skyway)
  set(CPACK_DEBIAN_MESH_PACKAGE_DEPENDS "libassimp5, libexpat1${skyway_part_depends}")
endif()

if(SKYWAY_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  skyway_package(python python3-skyway python "Python module of the Skyway toolkit
Makes box maps, reads them, lattices, roadmaps, paths, trajectories and reports
into NumPy arrays, answers collision queries in batches without copying, plans,
solves and checks.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${SKYWAY_PYTHON_DEPENDS}, ${skyway_loaded}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS skyway)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "skyway-footprints, skyway-cloud, skyway-mesh")
endif()

include(CPack)
