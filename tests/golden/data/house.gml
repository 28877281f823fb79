<?xml version='1.0' encoding='UTF-8'?>
<core:CityModel xmlns:core='http://www.opengis.net/citygml/2.0' xmlns:bldg='http://www.opengis.net/citygml/building/2.0' xmlns:gen='http://www.opengis.net/citygml/generics/2.0' xmlns:dem='http://www.opengis.net/citygml/relief/2.0' xmlns:gml='http://www.opengis.net/gml' xmlns:xlink='http://www.w3.org/1999/xlink'>
<core:cityObjectMember><bldg:Building gml:id='house'>
<gen:measureAttribute name='ridge'><gen:value uom='m'>7</gen:value></gen:measureAttribute>
<bldg:measuredHeight uom='m'>8</bldg:measuredHeight><bldg:storeysAboveGround>2</bldg:storeysAboveGround>
<bldg:lod2Solid><gml:Solid srsName='urn:ogc:def:crs:EPSG::25832'><gml:exterior><gml:CompositeSurface>
<gml:surfaceMember xlink:href='#south'/><gml:surfaceMember xlink:href='#north'/><gml:surfaceMember xlink:href='#west'/><gml:surfaceMember xlink:href='#east'/><gml:surfaceMember xlink:href='#ground'/>
</gml:CompositeSurface></gml:exterior></gml:Solid></bldg:lod2Solid>
<bldg:boundedBy><bldg:RoofSurface><bldg:lod2MultiSurface><gml:MultiSurface>
<gml:surfaceMember><gml:Polygon gml:id='south'><gml:exterior><gml:LinearRing><gml:posList>457842 5439083 115 457854 5439083 115 457854 5439088 119 457842 5439088 119 457842 5439083 115</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>
<gml:surfaceMember><gml:Polygon gml:id='north'><gml:exterior><gml:LinearRing><gml:posList>457854 5439093 115 457842 5439093 115 457842 5439088 119 457854 5439088 119 457854 5439093 115</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>
</gml:MultiSurface></bldg:lod2MultiSurface></bldg:RoofSurface></bldg:boundedBy>
<bldg:boundedBy><bldg:WallSurface><bldg:lod2MultiSurface><gml:MultiSurface>
<gml:surfaceMember><gml:Polygon gml:id='west'><gml:exterior><gml:LinearRing><gml:posList>457842 5439083 111 457842 5439083 115 457842 5439088 119 457842 5439093 115 457842 5439093 111 457842 5439083 111</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>
<gml:surfaceMember><gml:Polygon gml:id='east'><gml:exterior><gml:LinearRing><gml:posList>457854 5439083 111 457854 5439093 111 457854 5439093 115 457854 5439088 119 457854 5439083 115 457854 5439083 111</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>
</gml:MultiSurface></bldg:lod2MultiSurface></bldg:WallSurface></bldg:boundedBy>
<bldg:boundedBy><bldg:GroundSurface><bldg:lod2MultiSurface><gml:MultiSurface>
<gml:surfaceMember><gml:Polygon gml:id='ground'><gml:exterior><gml:LinearRing><gml:posList>457842 5439083 111 457842 5439093 111 457854 5439093 111 457854 5439083 111 457842 5439083 111</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:surfaceMember>
</gml:MultiSurface></bldg:lod2MultiSurface></bldg:GroundSurface></bldg:boundedBy>
</bldg:Building></core:cityObjectMember>
</core:CityModel>
