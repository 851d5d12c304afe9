// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/SessionTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct SessionTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::SessionTexts)
};

} // namespace

QStringList deidentifiedTexts(const core::DeidentifiedSession& session)
{
    const QString steps = session.steps == 1
        ? SessionTexts::tr("1 step")
        : SessionTexts::tr("%1 steps", nullptr, int(session.steps)).arg(session.steps);
    QStringList sentences{
        SessionTexts::tr("A session of %1 without where its study was, UIDs, authors and pictures; "
                         "%2. Every hash was compared.")
            .arg(steps, session.method)};
    if (session.imagesLeftOut)
        sentences += SessionTexts::tr("The study's images were left out.");
    sentences +=
        SessionTexts::tr("Names of segments, sculpt layers and bookmarks stay as they are.");
    return sentences;
}

} // namespace ui
