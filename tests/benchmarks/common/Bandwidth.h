// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace bench {

/// How much this machine's memory moves, all processors at once, in bytes per second: the best of
/// several turns over more than caches hold. Each byte that is read or written counts once.
struct Bandwidth {
    double triad = 0.0; ///< a = b + s · c, as in STREAM
    double copy = 0.0; ///< memcpy
};
[[nodiscard]] Bandwidth measuredBandwidth();

} // namespace bench
