# What `cpack -G DEB` makes of the installed files. tools/package runs it.
set(debian_made ${PROJECT_BINARY_DIR}/debian)
set(debian_revision 1)
set(POLHODE_MAINTAINER "Polhode authors <polhode@lists.invalid>" CACHE STRING "who answers for the .deb: NAME <ADDRESS>")

# The date of the package is that of the commit, so that the same sources give the same package.
set(source_date "$ENV{SOURCE_DATE_EPOCH}")
if(source_date STREQUAL "")
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%ct
    OUTPUT_VARIABLE source_date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(source_date STREQUAL "")
  file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md source_date "%s" UTC)
endif()
set(ENV{SOURCE_DATE_EPOCH} ${source_date})
string(TIMESTAMP changelog_date "%a, %d %b %Y %H:%M:%S +0000" UTC)

file(MAKE_DIRECTORY ${debian_made})
file(WRITE ${debian_made}/changelog.Debian
  "polhode (${PROJECT_VERSION}-${debian_revision}) unstable; urgency=medium

  * What is new is told by changelog.gz beside this file.

 -- ${POLHODE_MAINTAINER}  ${changelog_date}
")
configure_file(CHANGELOG.md ${debian_made}/changelog COPYONLY)
execute_process(COMMAND gzip -9nf ${debian_made}/changelog.Debian ${debian_made}/changelog COMMAND_ERROR_IS_FATAL ANY)

install(FILES ${debian_made}/changelog.Debian.gz ${debian_made}/changelog.gz packaging/copyright
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT debian EXCLUDE_FROM_ALL)
install(FILES ${made}/polhode.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _polhode
  COMPONENT debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME polhode)
set(CPACK_PACKAGE_VENDOR "Polhode authors")
set(CPACK_PACKAGE_CONTACT "${POLHODE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL Unspecified debian)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${debian_revision})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "physically exact films of spinning bodies
Polhode turns a short scene file into a film of a spinning body: the body,
its angular velocity and angular momentum, the precession cone and the
geometry behind them, as MP4, WebM, MOV, GIF, APNG or PNG, rendered without
a window. It also writes motions as tables, charts the speed of integrators
against their accuracy, compares pictures, and makes lectures from Markdown.")

# dpkg-shlibdeps finds the libraries that the program is linked with; these are opened or run by name
# when they are needed, and are unknown to it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
string(REGEX MATCH "^[0-9]+" libavfilter_major "${LIBAVFILTER_VERSION}")
string(JOIN ", " CPACK_DEBIAN_PACKAGE_DEPENDS
  libosmesa6                        # draws
  libavfilter${libavfilter_major}   # palettes of GIF films
  "gnuplot-nox | gnuplot"           # charts and maps
  fonts-inter fonts-urw-base35 fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, libegl-mesa0, libgl1-mesa-dri")  # draws on a graphics card
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "pandoc, chromium, fonts-lmodern, ffmpeg, slurm-client")   # lectures, clusters

include(CPack)
