<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.10.2" name="ground" tilewidth="16" tileheight="16" tilecount="8" columns="8">
 <image source="ground.png" width="128" height="16"/>
 <tile id="0" type="solid">
  <properties><property name="color" type="color" value="#ff5a8f3c"/></properties>
 </tile>
 <tile id="1" type="solid">
  <properties><property name="color" type="color" value="#ff7a5a3a"/></properties>
 </tile>
 <tile id="2">
  <properties><property name="color" type="color" value="#ff5a8f3c"/></properties>
  <objectgroup draworder="index" id="2"><object id="1" x="0" y="16"><polygon points="0,0 16,-16 16,0"/></object></objectgroup>
 </tile>
 <tile id="3">
  <properties><property name="color" type="color" value="#ff5a8f3c"/></properties>
  <objectgroup draworder="index" id="2"><object id="1" x="0" y="0"><polygon points="0,0 16,16 0,16"/></object></objectgroup>
 </tile>
 <tile id="4" type="oneWay">
  <properties><property name="color" type="color" value="#ffc8a25c"/><property name="look" value="platform"/></properties>
  <objectgroup draworder="index" id="2"><object id="1" x="0" y="0" width="16" height="6"/></objectgroup>
 </tile>
 <tile id="5" type="solid">
  <properties><property name="color" type="color" value="#ff9fd6ef"/><property name="friction" type="float" value="0.02"/></properties>
 </tile>
 <tile id="6" type="sensor">
  <properties><property name="color" type="color" value="#ffc84646"/><property name="name" value="spikes"/></properties>
  <objectgroup draworder="index" id="2"><object id="1" x="0" y="8" width="16" height="8"/></objectgroup>
 </tile>
 <tile id="7" type="spawn">
  <properties><property name="name" value="coin"/></properties>
 </tile>
</tileset>
