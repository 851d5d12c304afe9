# SPDX-License-Identifier: Apache-2.0
"""What pydicom makes of a Secondary Capture, as JSON.

usage: picture_facts.py FILE
"""
import base64
import json
import sys

import pydicom

picture = pydicom.dcmread(sys.argv[1])
pixels = picture.pixel_array
print(json.dumps({
    "patientName": str(picture.PatientName),
    "study": str(picture.StudyInstanceUID),
    "series": str(picture.SeriesInstanceUID),
    "burnedIn": picture.BurnedInAnnotation,
    "shape": list(pixels.shape),
    "pixels": base64.b64encode(pixels.tobytes()).decode(),
}))
