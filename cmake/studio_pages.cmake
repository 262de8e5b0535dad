# Builds the studio's pages with Vite: cmake -DWEB=web/ -DOUTPUT=DIR -DSTAMP=FILE -P studio_pages.cmake
# Without node or the npm packages nothing is built; `fastscene studio` then says what is missing.
find_program(NODE NAMES node nodejs)
set(vite ${WEB}/node_modules/vite/bin/vite.js)
if(NOT NODE OR NOT EXISTS ${vite} OR NOT EXISTS ${WEB}/node_modules/preact)
  message(STATUS "the studio's pages are not built: node or web/node_modules is missing")
  return()
endif()
execute_process(COMMAND ${NODE} ${vite} build --config ${WEB}/studio/vite.config.mjs --outDir ${OUTPUT} --logLevel warn
  WORKING_DIRECTORY ${WEB} COMMAND_ERROR_IS_FATAL ANY)
file(TOUCH ${STAMP})
