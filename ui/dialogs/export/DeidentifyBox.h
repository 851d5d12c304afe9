// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/deidentify/Deidentifier.h"

#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace ui {

/// Whether an export is to name the patient, and what it keeps if not. Begins with the patient
/// named; what else was chosen last is kept in the settings, and so is the secret by which exports
/// of this user fit each other.
class DeidentifyBox : public QWidget {
    Q_OBJECT

public:
    explicit DeidentifyBox(QWidget* parent = nullptr);

    /// Null: the patient stays named.
    [[nodiscard]] std::shared_ptr<const core::Deidentifier> deidentifier(
        const core::StudyIdentity& patient) const;
    /// Of a session: always without the patient, and asks only what a session holds.
    void askForSession();

Q_SIGNALS:
    void changed();

private:
    void showChoice();

    QCheckBox* m_wanted = nullptr;
    QWidget* m_details = nullptr;
    QComboBox* m_dates = nullptr;
    QSpinBox* m_days = nullptr;
    QCheckBox* m_device = nullptr;
    QCheckBox* m_descriptions = nullptr;
    QCheckBox* m_linked = nullptr;
};

} // namespace ui
