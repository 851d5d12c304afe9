// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/series/SyntheticSeries.h"

#include <QByteArrayList>

namespace test {

/// A series that identifies the patient in every place that DICOM has for it: names, numbers,
/// dates, texts, nested items, private attributes, overlays, UIDs. Each such value contains one of
/// markers().
[[nodiscard]] SyntheticSeries markedSeries();
/// The byte strings that must not occur in anything that is de-identified.
[[nodiscard]] QByteArrayList markers();
/// The markers that occur in a file, as it is or after decompression (deflated DICOM, gzip).
[[nodiscard]] QByteArrayList markersIn(const QString& file);

} // namespace test
