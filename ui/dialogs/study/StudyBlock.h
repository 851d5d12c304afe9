// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QFrame>

namespace ui {

/// Whose study it is that something is exported of, which series and point in time, and what its
/// reader must be warned of.
class StudyBlock : public QFrame {
    Q_OBJECT

public:
    explicit StudyBlock(const core::Volume& volume, QWidget* parent = nullptr);

private:
    void addLine(const QString& text, const char* role, const char* name = "");
};

} // namespace ui
