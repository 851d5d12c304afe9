// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// The paths opened last, newest first, across runs; those that are gone are left out. Paths only,
/// and how far apart the voxels of pictures are, which was given once: whose studies they are is
/// not kept.
class RecentStudies {
public:
    static constexpr int kept = 8;

    [[nodiscard]] static QStringList paths();
    /// @param series for core::Study::load(), of pictures whose spacing was given
    static void add(const QString& path, const QString& series = {});
    /// What add() was told of it; empty: nothing.
    [[nodiscard]] static QString seriesOf(const QString& path);
};

} // namespace ui
