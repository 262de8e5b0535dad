# The program with its data, manual pages and completion. A build tree is laid out as an installed one, with links
# instead of copies, so that base/data_files.h finds data in both.
set(FASTSCENE_DATA_DIR ${CMAKE_INSTALL_DATADIR}/fastscene)
set(FASTSCENE_WEB ${PROJECT_SOURCE_DIR}/web/node_modules/@playcanvas)

# ../share/fastscene beside bin/. npm may fill the folders later.
set(data ${PROJECT_BINARY_DIR}/share/fastscene)
file(MAKE_DIRECTORY ${data})
file(CREATE_LINK ${FASTSCENE_WEB}/supersplat-viewer ${data}/supersplat-viewer SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/packaging ${data}/packaging SYMBOLIC)

# The studio's pages are built with the program.
file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/studio/*)
set(stamp ${PROJECT_BINARY_DIR}/studio_pages.stamp)
add_custom_command(OUTPUT ${stamp}
  COMMAND ${CMAKE_COMMAND} -DWEB=${PROJECT_SOURCE_DIR}/web -DOUTPUT=${data}/studio -DSTAMP=${stamp}
    -P ${PROJECT_SOURCE_DIR}/cmake/studio_pages.cmake
  DEPENDS ${pages} ${PROJECT_SOURCE_DIR}/web/package-lock.json ${PROJECT_SOURCE_DIR}/cmake/studio_pages.cmake
  COMMENT "Building the studio's pages" VERBATIM)
add_custom_target(fastscene_studio_pages DEPENDS ${stamp})
add_dependencies(fastscene fastscene_studio_pages)

install(TARGETS fastscene RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(CODE "if(NOT EXISTS \"${FASTSCENE_WEB}/supersplat-viewer/public/index.html\")
  message(WARNING \"the viewer is not in web/node_modules: the installed program makes no viewer.html; \"
    \"run `npm ci --ignore-scripts` in web/ first\")
endif()" COMPONENT program)
install(DIRECTORY ${FASTSCENE_WEB}/supersplat-viewer/public DESTINATION ${FASTSCENE_DATA_DIR}/supersplat-viewer
  COMPONENT program OPTIONAL PATTERN "*.map" EXCLUDE)
install(FILES ${FASTSCENE_WEB}/supersplat-viewer/LICENSE DESTINATION ${FASTSCENE_DATA_DIR}/supersplat-viewer
  COMPONENT program OPTIONAL)
install(CODE "if(NOT EXISTS \"${data}/studio/index.html\")
  message(WARNING \"the studio's pages were not built: node or web/node_modules was missing\")
endif()" COMPONENT program)
install(DIRECTORY ${data}/studio DESTINATION ${FASTSCENE_DATA_DIR} COMPONENT program OPTIONAL)
# The manual pages are the program's own --help in troff.
install(CODE "execute_process(
  COMMAND bash \"${PROJECT_SOURCE_DIR}/packaging/man.sh\" \"$<TARGET_FILE:fastscene>\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\"
  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/packaging/completion.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME fastscene COMPONENT program)
