#pragma once
// The header of Windows, which headers of oneTBB include, before any other code, so that it cannot take names from
// that: no macros min, max, near, far, IN, OUT and ERROR. The compiler is told to read this first
// (cmake/compiler.cmake).
#define NOGDI
#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#define _WIN32_WINNT 0x0A00
#include <windows.h>
#undef far
#undef near
#undef IN
#undef OUT
