// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace ui {

class DeidentifyBox;
class Workspace;

/// The format of an export, a description of it, and its options: coordinate system, compression,
/// how the segments were made, whether the patient is named.
class ExportOptions : public QWidget {
    Q_OBJECT

public:
    explicit ExportOptions(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] core::ExportFormat format() const;
    /// Chooses a format, if it is possible for the volume.
    void choose(core::ExportFormat format);
    [[nodiscard]] const core::ExportFormatFacts& facts() const { return core::factsOf(format()); }
    /// Writes format, coordinate system, settings and de-identification into the request.
    void putInto(core::ExportRequest& request) const;
    /// What is wrong with them, as a sentence; empty: nothing.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    void formatChanged();
    void changed(); ///< any other choice

private:
    void fillFormats();
    void showFormat();

    Workspace& m_workspace;
    QComboBox* m_format = nullptr;
    QLabel* m_says = nullptr;
    QComboBox* m_space = nullptr; ///< for surfaces
    QLabel* m_spaceName = nullptr;
    QComboBox* m_algorithm = nullptr; ///< for DICOM SEG
    QLabel* m_algorithmName = nullptr;
    QCheckBox* m_deflated = nullptr;
    QLabel* m_obstacle = nullptr;
    DeidentifyBox* m_deidentify = nullptr;
};

} // namespace ui
