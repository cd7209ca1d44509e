# What `cmake --install` puts where: the program, the manual pages and completions that it writes itself, and what
# belongs to it in share/. Before that, build the target installed_files.
include(GNUInstallDirs)
set(made ${PROJECT_BINARY_DIR}/packaging)

# The build folder looks like an installed one to its binary (base/shipped_files.h).
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/polhode)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_BINARY_DIR}/share/polhode/scenes SYMBOLIC)

add_custom_command(OUTPUT ${made}/written
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:polhode> -DFOLDER=${made} -P ${CMAKE_CURRENT_LIST_DIR}/write_files.cmake
  DEPENDS polhode ${CMAKE_CURRENT_LIST_DIR}/write_files.cmake
  VERBATIM)
add_custom_target(installed_files DEPENDS ${made}/written)

install(TARGETS polhode)
install(DIRECTORY ${made}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${made}/polhode.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME polhode)
install(FILES ${made}/polhode.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _polhode COMPONENT local)
install(FILES ${made}/scene.schema.json ${made}/film.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/polhode)
if(TARGET page_core)
  install(FILES ${PROJECT_BINARY_DIR}/share/polhode/page/core.wasm.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/polhode/page)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/polhode)
install(FILES README.md ARCHITECTURE.md CONTRIBUTING.md packaging/THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT local)

include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
