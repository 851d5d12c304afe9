// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace core {

/// Whether a name comes before another as people number them: slice2 before slice10, whatever the
/// case of letters. The same on every machine.
[[nodiscard]] bool comesBefore(const QString& name, const QString& other);

/// Between two files that follow each other, numbers that no file has.
struct NumberGap {
    int after = 0; ///< 0-based: the file before it
    qint64 missing = 0;
};
/// Gaps in names that are alike but for one number and go up by the same step; nothing where they
/// are not. @param names in natural order
[[nodiscard]] std::vector<NumberGap> numberGaps(const QStringList& names);

} // namespace core
