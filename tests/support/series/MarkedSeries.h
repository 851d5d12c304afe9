// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/series/SyntheticSeries.h"

#include <QByteArrayList>

namespace test {

/// A series that tells who the patient is wherever DICOM has room for it: names, numbers, dates,
/// texts, nested items, private attributes, overlays, UIDs. Each such value holds one of markers().
[[nodiscard]] SyntheticSeries markedSeries();
/// What must not be found in anything that is de-identified.
[[nodiscard]] QByteArrayList markers();
/// Which of them a file holds, as it lies there or once it is inflated (deflated DICOM, gzip).
[[nodiscard]] QByteArrayList markersIn(const QString& file);

} // namespace test
