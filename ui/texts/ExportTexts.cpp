// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ExportTexts.h"

#include <QCoreApplication>

namespace ui {

namespace {

struct ExportTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::ExportTexts)
};

} // namespace

QString exportRemarkText(core::ExportRemark remark)
{
    using core::ExportRemark;
    switch (remark) {
    case ExportRemark::Empty:
        return ExportTexts::tr("empty");
    case ExportRemark::Hidden:
        return ExportTexts::tr("hidden");
    case ExportRemark::GrowthNotFinished:
        return ExportTexts::tr("growth not finished");
    case ExportRemark::SurfaceNotWrittenBack:
        return ExportTexts::tr("surface not written back");
    case ExportRemark::NotCoded:
        return ExportTexts::tr("not coded yet");
    }
    return {};
}

} // namespace ui
