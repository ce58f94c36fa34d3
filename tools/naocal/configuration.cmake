# Installs the configuration as it is shipped: without the folders of single robots, which hold what these have learned
# or what a person keeps for them, and without what a save leaves beside its files.
set(shipped ${CMAKE_SOURCE_DIR}/home/configuration)
set(leftovers PATTERN *.previous EXCLUDE PATTERN unfinished-save.json EXCLUDE PATTERN *.part EXCLUDE)
install(DIRECTORY ${shipped} DESTINATION share/naocal COMPONENT configuration
  REGEX "/location/[^/]+/(head|body)$" EXCLUDE ${leftovers})
file(GLOB halves RELATIVE ${shipped} CONFIGURE_DEPENDS ${shipped}/location/*/head/default ${shipped}/location/*/body/default)
foreach(half IN LISTS halves)
  install(DIRECTORY ${shipped}/${half}/ DESTINATION share/naocal/configuration/${half} COMPONENT configuration ${leftovers})
endforeach()
