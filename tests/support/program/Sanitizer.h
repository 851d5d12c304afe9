// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifndef __has_feature
#define __has_feature(feature) 0 // clang alone tells
#endif

namespace test {

/// Whether the program was built with the thread sanitizer (packaging/tsan.sh). It reserves
/// terabytes of addresses, and ends a program that asks for more memory than there is.
inline constexpr bool underThreadSanitizer = __has_feature(thread_sanitizer);

/// The same for the address sanitizer (packaging/asan.sh). It has its own allocator, before which
/// no library can be preloaded, and it reads files when an exception is thrown.
inline constexpr bool underAddressSanitizer = __has_feature(address_sanitizer);

inline constexpr bool underSanitizer = underThreadSanitizer || underAddressSanitizer;

/// How many times as long one waits before one says that something hangs.
inline constexpr int slowness = underSanitizer ? 6 : 1;

} // namespace test
