# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What package.xml needs stands in docs/install.md, and rules for rosdep are of its keys alone.

Run with: python3 -m unittest discover -s test/tools -p '*_test.py'
"""
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
OF_EVERY_ROS = re.compile(r"catkin|message_runtime|\w+_(msgs|srvs)")  # docs/install.md says "the messages"


def keys_of_package():
    package = ElementTree.parse(ROOT / "package.xml").getroot()
    return {element.text for element in package if element.tag.endswith("depend")}


class Dependencies(unittest.TestCase):
    def test_each_is_in_the_page_of_installing(self):
        named = set(re.findall(r"`([\w-]+)`", (ROOT / "docs/install.md").read_text()))
        self.assertEqual({key for key in keys_of_package() - named if not OF_EVERY_ROS.fullmatch(key)}, set())

    def test_rules_are_of_keys_and_packages_in_use(self):
        rules = yaml.safe_load((ROOT / "scripts/rosdep.yaml").read_text())
        installed = set((ROOT / "scripts/common.sh").read_text().split())
        for key, systems in rules.items():
            self.assertIn(key, keys_of_package())
            self.assertEqual(set(systems), {"debian", "ubuntu"}, key)
            for packages in systems.values():
                self.assertLessEqual(set(packages), installed, key)


if __name__ == "__main__":
    unittest.main()
