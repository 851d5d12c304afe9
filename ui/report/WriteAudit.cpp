// SPDX-License-Identifier: Apache-2.0
#include "ui/report/WriteAudit.h"

#include "core/base/files/StagedFile.h"
#include "ui/report/AuditHtml.h"
#include "ui/report/AuditPages.h"

#include <QBuffer>
#include <QFile>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace ui {

namespace {

constexpr int dotsPerInch = 600;

bool isPdf(const QString& path)
{
    return path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
}

QByteArray pdf(const AuditTexts& texts)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({});
    writer.setTitle(texts.title);
    writer.setCreator(QStringLiteral("Burin"));
    const AuditPages pages(texts, QSizeF(writer.width(), writer.height()));
    QPainter painter(&writer);
    for (int page = 0; page < pages.count(); ++page) {
        if (page > 0)
            writer.newPage();
        pages.paint(painter, page);
    }
    painter.end();
    return buffer.data();
}

} // namespace

QString auditNameProblem(const QString& path)
{
    for (const char* ending : {".html", ".htm", ".pdf"}) {
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            return {};
    }
    return QObject::tr("the name of a report ends in .html or .pdf");
}

core::Result<void> writeAudit(const core::AuditReport& report, const QString& path,
    bool replaceExisting, const AuditSegments* segments)
{
    core::Result<core::StagedFile> staged = core::StagedFile::create(path, replaceExisting);
    if (!staged)
        return tl::unexpected(staged.error());
    QFile file(staged->path());
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate))
        return core::failure(core::ErrorCode::FileUnwritable, path, file.errorString());
    const AuditTexts texts = AuditTexts::of(report, segments);
    const QByteArray bytes = isPdf(path) ? pdf(texts) : auditHtml(texts).toUtf8();
    if (file.write(bytes) != bytes.size() || !file.flush())
        return core::failure(core::ErrorCode::FileUnwritable, path, file.errorString());
    file.close();
    return staged->commit();
}

} // namespace ui
