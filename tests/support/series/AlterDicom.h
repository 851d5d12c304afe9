// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QString>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <functional>

namespace test {

/// Changes elements of a DICOM file and stores it with its original transfer syntax. Failures are
/// reported to Qt Test, as in a test function.
inline void alterDicom(const QString& file, const std::function<void(DcmDataset&)>& change)
{
    DcmFileFormat format;
    const QByteArray name = QFile::encodeName(file);
    QVERIFY(format.loadFile(name.constData()).good());
    DcmDataset& set = *format.getDataset();
    QVERIFY(set.loadAllDataIntoMemory().good());
    change(set);
    QVERIFY(format.saveFile(name.constData(), set.getOriginalXfer()).good());
}

} // namespace test
