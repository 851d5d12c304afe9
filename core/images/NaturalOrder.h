// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace core {

/// Whether a name comes before another in natural order: slice2 before slice10, ignoring case. The
/// same on every machine.
[[nodiscard]] bool comesBefore(const QString& name, const QString& other);

/// Missing numbers between two consecutive files.
struct NumberGap {
    int after = 0; ///< 0-based index of the file before the gap
    qint64 missing = 0;
};
/// The gaps in names that differ in one number only, if that number increases in constant steps;
/// otherwise none.
/// @param names in natural order
[[nodiscard]] std::vector<NumberGap> numberGaps(const QStringList& names);

} // namespace core
