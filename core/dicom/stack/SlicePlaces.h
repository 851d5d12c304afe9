// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/volume/Volume.h"

#include <QByteArray>
#include <QString>

#include <map>
#include <vector>

namespace core {

/// The images of one plane at one position along its normal.
struct SlicePlace {
    double along = 0.0; ///< mm
    std::vector<ImageHeader> images{};
};

/// Sorts images of one grid (splitSeries()) by their position along row × column. File names,
/// instance numbers and slice locations are not used.
[[nodiscard]] std::vector<SlicePlace> sortIntoPlaces(std::vector<ImageHeader> images);

/// Compares the bytes of files. A file is read once at most, whatever the number of its frames.
class FileContents {
public:
    [[nodiscard]] bool areEqual(const QString& file, const QString& other);

private:
    [[nodiscard]] const QByteArray& hashOf(const QString& file);

    std::map<QString, QByteArray> m_hashes;
};

/// Drops images that have the position and UID of another one, or the same bytes.
/// @return what was dropped, in words
[[nodiscard]] std::vector<VolumeProblem> dropDuplicates(
    std::vector<SlicePlace>& places, FileContents& contents);

} // namespace core
