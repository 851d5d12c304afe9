// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/deidentify/Deidentifier.h"

#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace ui {

/// Options of an export for de-identification: whether it names the patient, and what it keeps if
/// not. At first the patient is named. The other choices are kept in the settings, and so is the
/// secret that makes exports of this user consistent with each other.
class DeidentifyBox : public QWidget {
    Q_OBJECT

public:
    explicit DeidentifyBox(QWidget* parent = nullptr);

    /// The chosen de-identification; null if the patient stays named.
    [[nodiscard]] std::shared_ptr<const core::Deidentifier> deidentifier(
        const core::StudyIdentity& patient) const;
    /// What is wrong with the choice, as a sentence; empty: nothing.
    [[nodiscard]] QString problem() const;
    /// For the export of a session: always removes the patient, and offers only what applies to a
    /// session.
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
