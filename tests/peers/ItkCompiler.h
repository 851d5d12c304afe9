// SPDX-License-Identifier: Apache-2.0
#pragma once

// Debian's ITK knows only the compiler it was built with, GCC, and refuses clang, which reads it as
// well. Included before everything else where clang compiles the peers: GCC 12 for this one header.
#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")
