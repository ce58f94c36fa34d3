# Debian packages by CPack: naocal (programs, configuration, manual, a sample set) and libnaocal-dev (the C++ library).
# toolchain/package builds them.
include(GNUInstallDirs)
set(packaging ${CMAKE_SOURCE_DIR}/toolchain/packaging)

# A sample set with pictures, and its truth beside it.
set(sample ${CMAKE_BINARY_DIR}/sample)
add_custom_command(OUTPUT ${sample}/captures.truth.json VERBATIM COMMENT "Simulating the sample set"
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${sample}
  COMMAND naocal simulate ${sample}/captures --poses 8 --samples 2 --images --size 320x240 --seed 1 --json ${sample}/simulated.json
  COMMAND naocal detect ${sample}/captures --json ${sample}/detected.json
  DEPENDS naocal)
add_custom_target(sample DEPENDS ${sample}/captures.truth.json)
install(DIRECTORY ${sample}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/naocal/examples COMPONENT package
  PATTERN simulated.json EXCLUDE PATTERN detected.json EXCLUDE)

# Who packages names themselves as Debian's tools know it: DEBFULLNAME and DEBEMAIL.
set(maintainer "naocal contributors <naocal@localhost.localdomain>")
if(DEFINED ENV{DEBEMAIL})
  set(name "naocal contributors")
  if(DEFINED ENV{DEBFULLNAME})
    set(name $ENV{DEBFULLNAME})
  endif()
  set(maintainer "${name} <$ENV{DEBEMAIL}>")
endif()
set(documents ${CMAKE_BINARY_DIR}/documents)
add_custom_command(OUTPUT ${documents}/changelog.gz VERBATIM COMMENT "Writing the packages' changelog"
  COMMAND ${packaging}/changelog ${PROJECT_VERSION} ${maintainer} ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${documents}
  DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md ${packaging}/changelog)
add_custom_target(documents DEPENDS ${documents}/changelog.gz)
install(FILES ${packaging}/copyright ${documents}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/naocal COMPONENT package)
install(FILES ${packaging}/copyright ${documents}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libnaocal-dev COMPONENT library-package)
install(FILES ${documents}/CHANGELOG.md.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/naocal COMPONENT package)
install(FILES ${packaging}/naocal-panel.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${packaging}/naocal.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)

# What toolchain/package builds before.
add_custom_target(packaged ALL DEPENDS naocal naocal-robot mate-bridge manual sample documents naocal_library)
if(TARGET blind-writer)
  add_dependencies(packaged blind-writer blind-judge)
endif()

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_VENDOR naocal)
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL Unspecified configuration package library library-package)
foreach(component UNSPECIFIED CONFIGURATION PACKAGE)
  set(CPACK_COMPONENT_${component}_GROUP naocal)
endforeach()
foreach(component LIBRARY LIBRARY-PACKAGE)
  set(CPACK_COMPONENT_${component}_GROUP dev)
endforeach()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_NAOCAL_PACKAGE_NAME naocal)
set(CPACK_DEBIAN_NAOCAL_PACKAGE_SECTION science)
set(CPACK_DEBIAN_NAOCAL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_NAOCAL_PACKAGE_RECOMMENDS "chromium | firefox-esr | www-browser, man-db")
set(CPACK_DEBIAN_NAOCAL_DESCRIPTION "calibration of robots' joints and cameras from pictures
naocal estimates joint offsets and camera rotations of a NAO robot from
pictures of printed ChArUco boards, each with its uncertainty. Where offsets
do not explain the pictures, it names the missing effect and proposes poses
that decide between the explanations.

The package has the terminal program naocal, the panel mate-bridge, and
naocal-robot, which also simulates a robot.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libnaocal-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "naocal (= ${PROJECT_VERSION}), libboost-dev, libeigen3-dev, libfmt-dev, libmuparser-dev, libpng-dev, libssl-dev, libtbb-dev, liburdfdom-dev, libturbojpeg0-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "calibration of robots' joints and cameras from pictures (C++ library)
naocal estimates joint offsets and camera rotations of a NAO robot from
pictures of printed ChArUco boards, each with its uncertainty.

The package has the static libraries and headers, a CMake package and a
pkg-config file.")
include(CPack)
