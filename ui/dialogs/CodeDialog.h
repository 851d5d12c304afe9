// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace ui {

class CodeDetails;

/// Asks for the SNOMED CT concept of a segment: from a short list that typing narrows down, or any
/// other concept by value and meaning.
class CodeDialog : public QDialog {
    Q_OBJECT

public:
    /// @param segment its name, for the title and as the first search text
    CodeDialog(
        const QString& segment, const core::CodedConcept& present, QWidget* parent = nullptr);

    /// The chosen concept; empty before one is chosen.
    [[nodiscard]] core::CodedConcept code() const;
    /// Also asks for further codes that an export writes for the segment.
    void askDetails(const core::SegCodes& present);
    [[nodiscard]] core::SegCodes details() const;

private:
    void fillList();
    void choose(const QString& name);
    void narrow(const QString& letters);
    void takeRow();
    void check();

    QLineEdit* m_search = nullptr;
    QTreeWidget* m_list = nullptr;
    QLineEdit* m_value = nullptr;
    QLineEdit* m_meaning = nullptr;
    CodeDetails* m_details = nullptr; ///< null: not asked for
    QLabel* m_problem = nullptr;
    QPushButton* m_ok = nullptr;
};

/// A SNOMED CT identifier: 6 to 18 digits whose last one checks the others (Verhoeff).
[[nodiscard]] bool isSnomedIdentifier(const QString& value);

} // namespace ui
