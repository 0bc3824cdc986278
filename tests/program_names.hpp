#pragma once

// The programs under test as the shell takes them: those of this build, unless the environment names others.
#define GAPCHECK_PROGRAM "\"${GAPCHECK_PROGRAM:-" GAPCHECK_BINARY "}\""
#define CHECK_C_PROGRAM "\"${CHECK_C_PROGRAM:-" CHECK_C_BINARY "}\""
