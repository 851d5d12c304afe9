// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/SaveSessionDialog.h"

#include "ui/base/Theme.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QGridLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>

namespace ui {

SaveSessionDialog::SaveSessionDialog(const QString& folder, const QString& name, QWidget* parent)
    : QFileDialog(
        parent, tr("Save session as"), folder, tr("Sessions of Burin (*.burin);;All files (*)"))
    , m_images(new QCheckBox(tr("Include the study's images"), this))
    , m_hint(new QLabel(this))
{
    // A system's own dialog has no place for the question.
    setOption(QFileDialog::DontUseNativeDialog);
    setAcceptMode(QFileDialog::AcceptSave);
    setDefaultSuffix(QStringLiteral("burin"));
    // The name alone: a row that is chosen would count, whatever is typed afterwards.
    findChild<QLineEdit*>()->setText(name);
    for (const QAbstractItemView* list : findChildren<QAbstractItemView*>()) {
        if (list->selectionModel())
            list->selectionModel()->clear();
    }
    m_images->setObjectName(QStringLiteral("includeImages"));
    m_hint->setFont(theme::smallFont());
    m_hint->setProperty("role", QStringLiteral("secondary"));
    m_images->hide();
    m_hint->hide();
    connect(m_images, &QCheckBox::toggled, this, &SaveSessionDialog::explain);
}

void SaveSessionDialog::offerImages(bool included, bool studyThere)
{
    m_studyThere = studyThere;
    m_images->setChecked(included);
    explain();
    // Below the file's name and kind, in line with them.
    if (auto* grid = qobject_cast<QGridLayout*>(layout())) {
        const int row = grid->rowCount();
        grid->addWidget(m_images, row, 1, 1, 2);
        grid->addWidget(m_hint, row + 1, 1, 1, 2);
    }
    m_images->show();
    m_hint->show();
}

bool SaveSessionDialog::wantsImages() const
{
    return m_images->isChecked();
}

void SaveSessionDialog::explain()
{
    if (m_images->isChecked())
        m_hint->setText(
            tr("The images, and with them what identifies the patient, travel with the file."));
    else if (m_studyThere)
        m_hint->setText(tr("The file holds no image and no patient's name; it opens where the "
                           "study is at hand."));
    else
        m_hint->setText(tr("The study is not at hand: without its images this file opens nowhere "
                           "until it is found."));
}

} // namespace ui
