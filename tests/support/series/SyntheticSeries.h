// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class DcmDataset;

namespace test {

/// The description of a DICOM CT series for tests, including possible defects. Every field may be
/// set before writeSeries().
struct SyntheticSeries {
    glm::ivec3 size{24, 18, 10};
    glm::dvec2 spacing{0.75, 1.25}; ///< mm between columns (x), between rows (y)
    core::ImagePlane plane;
    glm::dvec3 origin{-9.0, -11.25, 40.0};
    glm::dvec3 step{0.0, 0.0, 2.5}; ///< from slice to slice
    std::vector<glm::dvec3> positions{}; ///< instead of origin and step; one per slice

    core::PixelLayout layout{.bitsAllocated = 16,
        .bitsStored = 12,
        .highBit = 11,
        .isSigned = false,
        .photometric = QStringLiteral("MONOCHROME2")};
    /// Fills unused bits with ones and zeros.
    bool dirtySpareBits = false;
    /// Stored value; must fit layout.bitsStored.
    std::function<int(const glm::ivec3& index)> stored = defaultStored;
    std::function<double(int k)> slope = [](int) { return 1.0; };
    std::function<double(int k)> intercept = [](int) { return -1024.0; };

    QString modality = QStringLiteral("CT");
    QString seriesUid = QStringLiteral("2.25.4711");
    QString studyUid = QStringLiteral("2.25.4712");
    QString transferSyntaxUid = QStringLiteral("1.2.840.10008.1.2.1");
    /// The file name of slice k; by default the order of names is unrelated to k.
    std::function<QString(int k)> fileName = shuffledName;
    /// Changes the data set of slice k just before it is written.
    std::function<void(DcmDataset& set, int k)> adjust = [](DcmDataset&, int) {};

    static int defaultStored(const glm::ivec3& index);
    static QString shuffledName(int k);

    /// The value that a loader must find at this index.
    [[nodiscard]] double value(const glm::ivec3& index) const;
    [[nodiscard]] glm::dvec3 position(int k) const;
};

/// Writes one file per slice into @p folder, which is created if needed; returns the paths in the
/// order of slices. Compresses with DCMTK's encoders if transferSyntaxUid is RLE, JPEG or JPEG-LS.
QStringList writeSeries(const SyntheticSeries& series, const QString& folder);

} // namespace test
