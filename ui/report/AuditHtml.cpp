// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditHtml.h"

#include <QFile>

namespace ui {

namespace {

QString element(const char* tag, const QString& text, const char* style = "")
{
    const QString attribute =
        *style ? QStringLiteral(" class=\"%1\"").arg(QLatin1String(style)) : QString();
    return QStringLiteral("<%1%2>%3</%1>").arg(QLatin1String(tag), attribute, text);
}

QString escaped(const QString& text)
{
    return text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
}

QString factList(const QString& heading, const std::vector<AuditTexts::Fact>& facts)
{
    QString rows;
    for (const AuditTexts::Fact& fact : facts)
        rows += element("dt", escaped(fact.name))
            + element("dd", escaped(fact.value), fact.isHash ? "hash" : "") + u'\n';
    return element("section", element("h2", heading) + element("dl", u'\n' + rows)) + u'\n';
}

QString stepRow(const AuditTexts::Step& step)
{
    QString what = escaped(step.what);
    if (!step.note.isEmpty())
        what += element("div", escaped(step.note), "note");
    const QString cells = element("td", step.number, "number") + element("td", step.when, "when")
        + element("td", escaped(step.who)) + element("td", what)
        + element("td", escaped(step.howMuch), "number") + element("td", step.hash, "hash");
    return element("tr", cells, step.stands ? "" : "gone") + u'\n';
}

QString stepTable(const AuditTexts& texts)
{
    QString heads;
    for (const char* head : {"#", "When (UTC)", "Who", "What", "How much", "State"})
        heads += element("th", QLatin1String(head));
    QString rows;
    for (const AuditTexts::Step& step : texts.steps)
        rows += stepRow(step);
    return element(
        "table", element("thead", element("tr", heads)) + u'\n' + element("tbody", u'\n' + rows));
}

QString segmentTable(const AuditTexts& texts)
{
    if (texts.segments.empty())
        return {};
    QString heads;
    for (const char* head : {"Segment", "Size", "Since it was imported"})
        heads += element("th", QLatin1String(head));
    QString rows;
    for (const AuditTexts::Segment& segment : texts.segments)
        rows += element("tr",
                    element("td", escaped(segment.name)) + element("td", escaped(segment.size))
                        + element("td", escaped(segment.change)))
            + u'\n';
    return element(
        "table", element("thead", element("tr", heads)) + u'\n' + element("tbody", u'\n' + rows));
}

QString figure(const AuditTexts::Picture& picture)
{
    const QString image =
        QStringLiteral("<img alt=\"%1\" src=\"data:image/png;base64,%2\">")
            .arg(picture.caption.toHtmlEscaped(), QString::fromLatin1(picture.png.toBase64()));
    return element("figure",
               image
                   + element("figcaption",
                       escaped(picture.caption)
                           + element("div", QStringLiteral("SHA-256 ") + picture.sha256, "hash")))
        + u'\n';
}

QString style()
{
    QFile file(QStringLiteral(":/burin/style/audit.css"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString figures(const std::vector<AuditTexts::Picture>& pictures)
{
    QString all;
    for (const AuditTexts::Picture& picture : pictures)
        all += figure(picture);
    return element("div", all, "pictures");
}

QString segmentSection(const AuditTexts& texts)
{
    if (texts.aboutSegments.isEmpty())
        return {};
    QString section = u'\n' + element("h2", QStringLiteral("Segments"))
        + element("p", escaped(texts.aboutSegments)) + segmentTable(texts);
    if (!texts.changes.empty())
        section += element("p", escaped(texts.aboutChanges)) + figures(texts.changes);
    return section;
}

} // namespace

QString auditHtml(const AuditTexts& texts)
{
    QString body = element(
        "header", element("h1", escaped(texts.title)) + element("p", escaped(texts.subtitle)));
    body += element("div",
        factList(QStringLiteral("Study"), texts.study)
            + factList(QStringLiteral("Session"), texts.session),
        "facts");
    body += element("div",
        element("strong", escaped(texts.verdict)) + element("p", escaped(texts.explanation)),
        texts.sound ? "verdict sound" : "verdict damaged");
    body += segmentSection(texts);
    body += u'\n' + element("h2", QStringLiteral("Steps"));
    body += texts.steps.empty() ? element("p", escaped(texts.noSteps)) : stepTable(texts);
    body += u'\n' + element("h2", QStringLiteral("Pictures"));
    const bool none = texts.pictures.empty();
    body += element("p", escaped(none ? texts.noPictures : texts.aboutPictures));
    body += figures(texts.pictures);
    body += element("footer", escaped(texts.footer));
    return QStringLiteral("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                          "<title>%1</title>\n<style>\n%2</style>\n</head>\n<body>\n%3\n</body>\n"
                          "</html>\n")
        .arg(escaped(texts.title), style(), body);
}

} // namespace ui
