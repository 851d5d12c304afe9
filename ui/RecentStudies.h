// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// The paths opened last, newest first, across runs; those that are gone are left out. Paths only:
/// whose studies they are is not kept.
class RecentStudies {
public:
    static constexpr int kept = 8;

    [[nodiscard]] static QStringList paths();
    static void add(const QString& path);
};

} // namespace ui
