# Embeds the mechanisms of cases/library and the scenes of cases/requests in the program.
set(library_mechanisms
  andrews delta double_wishbone inverted_slider_crank jansen_leg macpherson rssr slider_crank
  stephenson_six_bar stewart truck_axle watt_six_bar whitworth)
set(request_scenes wheel_centre damper dampers axle outputs)

set(DESMO_EMBEDDED_TEXTS "")
# desmo_embed(VARIABLE PATH): adds the bytes of a file to DESMO_EMBEDDED_TEXTS, as a C++ array.
function(desmo_embed variable path)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} text HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," text "${text}")
  set(DESMO_EMBEDDED_TEXTS
    "${DESMO_EMBEDDED_TEXTS}constexpr char ${variable}[] = {${text}};\n" PARENT_SCOPE)
endfunction()

set(DESMO_LIBRARY_TABLE "")
foreach(name IN LISTS library_mechanisms)
  desmo_embed(${name}_mechanism ${CMAKE_CURRENT_LIST_DIR}/library/${name}.json)
  desmo_embed(${name}_scene ${CMAKE_CURRENT_LIST_DIR}/library/${name}.scene.json)
  string(APPEND DESMO_LIBRARY_TABLE
    "      LibraryMechanism{\"${name}\", view(${name}_mechanism), view(${name}_scene)},\n")
endforeach()
set(DESMO_REQUEST_TABLE "")
foreach(name IN LISTS request_scenes)
  desmo_embed(${name}_request ${CMAKE_CURRENT_LIST_DIR}/requests/${name}.scene.json)
  string(APPEND DESMO_REQUEST_TABLE "      RequestScene{\"${name}\", view(${name}_request)},\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/library.cpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/library.cpp @ONLY)
