# Installs the library: `find_package(naocal)` and `naocal::naocal`, with the headers that its interface (naocal.hpp) needs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(folders math io data robot camera effects measurements estimation inference calibration setups diagnosis library)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/naocal)
foreach(folder IN LISTS folders)
  set_target_properties(naocal_${folder} PROPERTIES EXPORT_NAME ${folder})
  list(APPEND libraries naocal_${folder})
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/naocal COMPONENT library FILES_MATCHING PATTERN *.hpp)
endforeach()
set_target_properties(naocal_library PROPERTIES EXPORT_NAME naocal)
set_target_properties(naocal_options PROPERTIES EXPORT_NAME options)
install(FILES library/naocal.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/naocal COMPONENT library)
set_target_properties(naocal_instances PROPERTIES EXPORT_NAME instances)
install(TARGETS ${libraries} naocal_instances naocal_options EXPORT naocal COMPONENT library
  ARCHIVE COMPONENT library
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_INCLUDEDIR}/naocal)
install(EXPORT naocal NAMESPACE naocal:: FILE naocalTargets.cmake DESTINATION ${package} COMPONENT library)
configure_package_config_file(library/naocalConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/naocalConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/naocalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/naocalConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/naocalConfigVersion.cmake
  DESTINATION ${package} COMPONENT library)

# The same for pkg-config; the archives in the order in which they use each other.
set(archives "")
foreach(name IN LISTS folders)
  get_target_property(type naocal_${name} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(PREPEND archives "-lnaocal_${name} ")
  endif()
endforeach()
string(APPEND archives "-lnaocal_instances ")
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig "${prefix_from_pkgconfig}")
configure_file(${CMAKE_SOURCE_DIR}/toolchain/packaging/naocal.pc.in ${CMAKE_CURRENT_BINARY_DIR}/naocal.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/naocal.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
