// SPDX-License-Identifier: Apache-2.0
#include "ui/models/ViewStepText.h"

#include <QObject>

namespace ui {

namespace {

/// @param named "Hide '%1'"
/// @param counted "Hide %1 segments"
QString textFor(const std::vector<int>& labels, const core::Document* document,
    const QString& named, const QString& counted)
{
    const core::Segment* only =
        document && labels.size() == 1 ? document->segment(labels.front()) : nullptr;
    if (only)
        return named.arg(only->name);
    return counted.arg(labels.size());
}

} // namespace

QString viewStepText(const ViewSteps::Step& step, const core::Document* document)
{
    if (step.what == ViewSteps::What::Clip)
        return QObject::tr("Clip");
    if (step.shown.empty())
        return textFor(step.hidden, document, QObject::tr("Hide '%1'"),
            step.hidden.size() == 1 ? QObject::tr("Hide %1 segment")
                                    : QObject::tr("Hide %1 segments"));
    if (step.hidden.empty())
        return textFor(step.shown, document, QObject::tr("Show '%1'"),
            step.shown.size() == 1 ? QObject::tr("Show %1 segment")
                                   : QObject::tr("Show %1 segments"));
    return QObject::tr("Show and hide segments");
}

} // namespace ui
