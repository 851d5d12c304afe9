// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QFrame>

namespace ui {

/// The part of an export dialog that names the patient, study, series and point in time, and the
/// warnings that a reader of the export must know.
class StudyBlock : public QFrame {
    Q_OBJECT

public:
    explicit StudyBlock(const core::Volume& volume, QWidget* parent = nullptr);

private:
    void addLine(const QString& text, const char* role, const char* name = "");
};

} // namespace ui
