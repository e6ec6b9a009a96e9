<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The places of CGAL's manual that this one refers to, for plain doxygen. -->
<tagfile>
  <compound kind="page">
    <name>group__bgl__namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters</filename>
    <docanchor file="BGL/group__bgl__namedparameters.html" title="Named Parameters">bgl_namedparameters</docanchor>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
</tagfile>
