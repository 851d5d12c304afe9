// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/servers/WebServer.h"

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QStringList>

namespace test {

/// The answers of a sound DICOMweb server that holds the objects of one series, whatever is
/// searched for; what is sent to it, it says that it stored.
class WebArchive {
public:
    /// Reads the files. Ends the program if one is no DICOM file.
    explicit WebArchive(const QStringList& files);

    [[nodiscard]] const QMap<QByteArray, QByteArray>& objects() const { return m_objects; }
    [[nodiscard]] const QByteArray& studyUid() const { return m_studyUid; }
    /// @param line of the request, as WebServer::Answer gets it
    [[nodiscard]] WebReply answer(const QByteArray& line) const;

    /// Whether a request is for objects (WADO-RS), and not a search.
    [[nodiscard]] static bool asksForObjects(const QByteArray& line);
    /// The body in which objects are sent, and its type.
    [[nodiscard]] static QByteArray multipart(const QList<QByteArray>& objects);
    static constexpr const char* multipartType =
        "multipart/related; type=\"application/dicom\"; boundary=\"a-b\"";

private:
    QMap<QByteArray, QByteArray> m_objects; ///< by SOP instance UID
    QByteArray m_studyUid;
    QByteArray m_seriesUid;
};

} // namespace test
