# What `cmake --install` puts where: the program, its manual pages and completions, which it writes itself, and share/polhode.
include(GNUInstallDirs)
set(made ${PROJECT_BINARY_DIR}/packaging)

# The build folder looks like an installed one to its binary (base/shipped_files.h).
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/polhode)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_BINARY_DIR}/share/polhode/scenes SYMBOLIC)
