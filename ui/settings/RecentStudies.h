// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// The paths that were opened last, newest first, kept across runs; paths that do not exist at
/// present are left out, and come back with their drive. Only paths are stored, and the spacing
/// that the user gave for pictures; not whose studies they are.
class RecentStudies {
public:
    static constexpr int kept = 8;

    [[nodiscard]] static QStringList paths();
    /// @param series argument for core::Study::load(), for pictures whose spacing the user gave
    static void add(const QString& path, const QString& series = {});
    /// The series that add() was given; empty if none.
    [[nodiscard]] static QString seriesOf(const QString& path);
};

} // namespace ui
