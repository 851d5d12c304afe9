// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegSettings.h"

#include <QWidget>

class QComboBox;
class QFormLayout;

namespace ui {

/// Fields for what a DICOM SEG states about a segment besides its type: category, side, and the
/// anatomic region of a finding.
class CodeDetails : public QWidget {
    Q_OBJECT

public:
    explicit CodeDetails(QWidget* parent = nullptr);

    void setCodes(const core::SegCodes& codes);
    [[nodiscard]] core::SegCodes codes() const;
    /// Aligns forms that stand below each other, so that their fields begin at the same x.
    static void alignLabels(const QFormLayout& form);

private:
    QComboBox* m_category = nullptr;
    QComboBox* m_modifier = nullptr;
    QComboBox* m_region = nullptr;
    QComboBox* m_regionModifier = nullptr;
};

} // namespace ui
