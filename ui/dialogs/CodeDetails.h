// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegSettings.h"

#include <QWidget>

class QComboBox;
class QFormLayout;

namespace ui {

/// What a DICOM SEG says of a segment beside its type: category, side, and where a finding lies.
class CodeDetails : public QWidget {
    Q_OBJECT

public:
    explicit CodeDetails(QWidget* parent = nullptr);

    void setCodes(const core::SegCodes& codes);
    [[nodiscard]] core::SegCodes codes() const;
    /// Forms below each other begin their fields at one line.
    static void alignLabels(const QFormLayout& form);

private:
    QComboBox* m_category = nullptr;
    QComboBox* m_modifier = nullptr;
    QComboBox* m_region = nullptr;
    QComboBox* m_regionModifier = nullptr;
};

} // namespace ui
