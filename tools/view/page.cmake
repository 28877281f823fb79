# The page of skyway-view as C++: page/* in this order, and three.js from Debian's libjs-three.

find_file(THREE_JS three.min.js PATHS /usr/share/javascript/three REQUIRED)
set(page ${CMAKE_CURRENT_SOURCE_DIR}/view/page)
set(page_styles ${page}/theme.css ${page}/layout.css ${page}/controls.css)
set(page_scripts
  ${page}/inflate.js ${page}/data.js ${page}/format.js ${page}/element.js ${page}/theme.js ${page}/scale.js
  ${page}/knots.js ${page}/motion.js ${page}/mission.js ${page}/home.js ${page}/selection.js ${page}/quantity.js ${page}/clock.js
  ${page}/box_levels.js ${page}/boxes.js ${page}/outlines.js ${page}/ground.js ${page}/room.js ${page}/ribbon.js ${page}/ways.js ${page}/lattice.js ${page}/tree.js ${page}/corridor.js ${page}/tube.js
  ${page}/marker.js ${page}/drop_line.js ${page}/vehicle.js ${page}/fleet.js ${page}/home_lines.js ${page}/home_way.js ${page}/pair_line.js ${page}/pick.js ${page}/pick_line.js
  ${page}/mission_list.js ${page}/mission_labels.js
  ${page}/orbit.js ${page}/camera.js ${page}/compass.js ${page}/scale_bar.js ${page}/stage.js
  ${page}/plot.js ${page}/home_marks.js ${page}/transport.js ${page}/layers.js ${page}/frames.js ${page}/motion_panel.js ${page}/pairs_panel.js ${page}/summary_panel.js
  ${page}/checks_panel.js ${page}/home_panel.js ${page}/contents_panel.js ${page}/tabs.js ${page}/keyboard.js ${page}/help.js
  ${page}/state.js ${page}/main.js)
list(JOIN page_styles "|" joined_styles)
list(JOIN page_scripts "|" joined_scripts)
add_custom_command(
  OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/page_source.cpp
  COMMAND ${CMAKE_COMMAND} -DOUT=${CMAKE_CURRENT_BINARY_DIR}/page_source.cpp
          -DHTML=${page}/page.html -DTHREE=${THREE_JS} "-DSTYLES=${joined_styles}"
          "-DSCRIPTS=${joined_scripts}" -P ${CMAKE_CURRENT_SOURCE_DIR}/view/embed.cmake
  DEPENDS ${page}/page.html ${page_styles} ${page_scripts} ${THREE_JS}
          ${CMAKE_CURRENT_SOURCE_DIR}/view/embed.cmake
  VERBATIM)
