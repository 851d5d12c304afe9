// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/common/PeerReport.h"

#include <QString>

namespace bench {

/// decode.*: 320 slices of 512 × 512 in JPEG lossless, decoded in processes without rights
/// (core/fence) and, as the peer, in the program itself: the frames alone (".frames", on all
/// cores) and the whole way from the folder to the volume (".open"). The median of five turns, by
/// turns; decoders are running already, as after the first slices.
///
/// Adds its figures to @p report. Prints to stderr what it does.
/// @return why the results are not right, so that there are no figures; empty: there are
QString measureDecoding(PeerReport& report);

} // namespace bench
