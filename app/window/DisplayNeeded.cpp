// SPDX-License-Identifier: Apache-2.0
#include "app/window/DisplayNeeded.h"

#include <QByteArray>
#include <QString>

#include <cstdio>
#include <cstdlib>

#include <unistd.h>

namespace app {

namespace {

QtMessageHandler before = nullptr;
QByteArray reason; ///< the first that the platform's plugin says

void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
    if (type == QtFatalMsg) {
        const QByteArray why = reason.isEmpty() ? message.section(u'\n', 0, 0).toUtf8() : reason;
        std::fprintf(
            stderr, "burin: there is no display to show a window on: %s\n", why.constData());
        std::fflush(stderr);
        ::_exit(EXIT_FAILURE);
    }
    const QByteArray category = context.category;
    if (!category.startsWith("qt.qpa")) {
        if (before)
            before(type, context, message);
        return;
    }
    if (reason.isEmpty())
        reason = message.trimmed().toUtf8();
}

} // namespace

DisplayNeeded::DisplayNeeded()
    : m_before(qInstallMessageHandler(onMessage))
{
    before = m_before;
}

DisplayNeeded::~DisplayNeeded()
{
    qInstallMessageHandler(m_before);
    before = nullptr;
    reason.clear();
}

} // namespace app
