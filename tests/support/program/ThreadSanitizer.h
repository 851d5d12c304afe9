// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace test {

/// Whether this was built with the thread sanitizer (packaging/tsan.sh), which takes terabytes of
/// addresses for itself and ends a program that asks for more memory than there is.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
inline constexpr bool underThreadSanitizer = true;
#else
inline constexpr bool underThreadSanitizer = false;
#endif
#else
inline constexpr bool underThreadSanitizer = false;
#endif

} // namespace test
