// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/WebArchive.h"

#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace test {

WebArchive::WebArchive(const QStringList& files)
{
    for (const QString& path : files) {
        DcmFileFormat format;
        if (format.loadFile(QFile::encodeName(path).constData()).bad())
            qFatal("no DICOM file: %s", qPrintable(path));
        const auto uid = [&format](const DcmTagKey& tag) {
            OFString value;
            format.getDataset()->findAndGetOFString(tag, value);
            return QByteArray(value.c_str());
        };
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            qFatal("cannot read %s", qPrintable(path));
        m_objects.insert(uid(DCM_SOPInstanceUID), file.readAll());
        m_studyUid = uid(DCM_StudyInstanceUID);
        m_seriesUid = uid(DCM_SeriesInstanceUID);
    }
}

bool WebArchive::asksForObjects(const QByteArray& line)
{
    return line.startsWith("GET /dicom-web/studies/") && !line.contains('?');
}

QByteArray WebArchive::multipart(const QList<QByteArray>& objects)
{
    QByteArray body;
    for (const QByteArray& object : objects)
        body += "\r\n--a-b\r\nContent-Type: application/dicom\r\n\r\n" + object;
    return body + "\r\n--a-b--\r\n";
}

WebReply WebArchive::answer(const QByteArray& line) const
{
    const auto attribute = [](const char* tag, const QByteArray& value) {
        return "\"" + QByteArray(tag) + "\":{\"vr\":\"UI\",\"Value\":[\"" + value + "\"]}";
    };
    if (line.startsWith("POST "))
        return {.body = R"({"00081199":{"vr":"SQ","Value":[{}]}})"};
    if (asksForObjects(line)) {
        const QByteArray uid = line.mid(line.lastIndexOf('/') + 1);
        return {.contentType = multipartType,
            .body = multipart(
                m_objects.contains(uid) ? QList<QByteArray>{m_objects[uid]} : m_objects.values())};
    }
    if (line.contains("offset=") && !line.contains("offset=0"))
        return {.body = "[]"};
    QList<QByteArray> entries;
    if (line.contains("/instances?")) {
        for (const QByteArray& uid : m_objects.keys())
            entries.append("{" + attribute("00080018", uid) + "}");
    } else if (line.contains("/series?")) {
        entries.append("{" + attribute("0020000E", m_seriesUid) + "}");
    } else {
        entries.append("{" + attribute("0020000D", m_studyUid) + "}");
    }
    return {.body = "[" + entries.join(',') + "]"};
}

} // namespace test
