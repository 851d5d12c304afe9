// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/AboutDialog.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {

AboutDialog::AboutDialog(const QString& graphics, QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("About Burin"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 16);
    layout->setSpacing(16);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* row = new QHBoxLayout;
    row->setSpacing(20);
    auto* mark = new QLabel(this);
    mark->setPixmap(tintedIcon(QStringLiteral("burin"), theme::text, 64, devicePixelRatioF()));
    row->addWidget(mark, 0, Qt::AlignTop);
    auto* words = new QLabel(
        QStringLiteral(
            "<p style='font-size:16pt; margin:0'>Burin %1</p>"
            "<p>Segmentation workstation for CT and MR studies:<br>"
            "carve a study open, grow what you mark, sign the mask.</p>"
            "<p style='color:%2'><b>Research use; not a medical device.</b></p>"
            "<p style='color:%3'>After Chen, Samavati and Costa Sousa, point radiation for "
            "volume sculpting,<br>and Bornik, Beichel and Schmalstieg, segmentation "
            "refinement.<br>Apache License 2.0. Graphics: %4</p>")
            .arg(QCoreApplication::applicationVersion().toHtmlEscaped(), theme::caution.name(),
                theme::secondary.name(), graphics.toHtmlEscaped()),
        this);
    words->setTextFormat(Qt::RichText);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(words, 1);
    layout->addLayout(row);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace ui
