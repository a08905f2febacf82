// The report's turnable view: the faces' places, changes and rims as base64 in the page, and a
// script of its own that draws them by WebGL. Nothing is loaded from anywhere.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "report_pictures.hpp"

namespace mien::cli {
namespace {

// Places and changes are kept in hundredths of a millimetre as 16-bit numbers.
constexpr double kPerMm = 100;
constexpr double kMost = 32767;
constexpr std::int16_t kUnknown = -32768;
// What the view may take of a page that stays below 5 MB, in bytes before base64.
constexpr std::size_t kBudget = 1200000;

std::int16_t rounded(double mm) {
    return static_cast<std::int16_t>(std::lround(std::clamp(mm * kPerMm, -kMost, kMost)));
}

template <typename T>
std::string packed(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(&bytes[0], values.data(), bytes.size());
    return "\"" + base64(bytes) + "\"";
}

const char* const kScript = R"(
(function(){"use strict";
var d=JSON.parse(document.getElementById("faces").textContent);
var root=document.getElementById("view"),canvas=root.querySelector("canvas");
var gl=canvas.getContext("webgl",{preserveDrawingBuffer:true,antialias:true});
if(!gl||!gl.getExtension("OES_element_index_uint")){
 root.querySelector(".controls").hidden=true;canvas.hidden=true;
 root.querySelector(".none").hidden=false;return;}
function bytes(t){var s=atob(t),b=new Uint8Array(s.length);for(var i=0;i<s.length;i++)b[i]=s.charCodeAt(i);return b.buffer;}
var tri=new Uint32Array(bytes(d.triangles)),rim=new Uint32Array(bytes(d.rims));
function shader(kind,text){var s=gl.createShader(kind);gl.shaderSource(s,text);gl.compileShader(s);return s;}
var prog=gl.createProgram();
gl.attachShader(prog,shader(gl.VERTEX_SHADER,"attribute vec3 p,n,c;uniform mat3 r;uniform vec3 o;uniform float z,lift;varying vec3 vn,vc;void main(){vec3 q=r*(p-o)*z;vn=r*n;vc=c;gl_Position=vec4(q.x,q.y,-q.z*0.3-lift,1.0);}"));
gl.attachShader(prog,shader(gl.FRAGMENT_SHADER,"precision mediump float;varying vec3 vn,vc;uniform float flat_;void main(){vec3 n=normalize(vn);if(n.z<0.0)n=-n;float l=0.28+0.56*max(0.0,dot(n,normalize(vec3(-0.45,0.55,0.75))))+0.30*max(0.0,dot(n,normalize(vec3(0.75,0.1,0.55))));gl_FragColor=vec4(vc*mix(l,1.0,flat_),1.0);}"));
gl.linkProgram(prog);gl.useProgram(prog);gl.enable(gl.DEPTH_TEST);gl.clearColor(1,1,1,1);
function at(name){return gl.getUniformLocation(prog,name);}
function buffer(kind,data){var b=gl.createBuffer();gl.bindBuffer(kind,b);gl.bufferData(kind,data,gl.STATIC_DRAW);return b;}
var triAt=buffer(gl.ELEMENT_ARRAY_BUFFER,tri),rimAt=buffer(gl.ELEMENT_ARRAY_BUFFER,rim);
function colour(v,range){
 if(v===-32768)return[0.51,0.51,0.51];
 var t=Math.max(-1,Math.min(1,v/100/range)),e=t>0?[178,34,40]:[44,84,178],a=Math.abs(t),w=0.35*a*a+0.65*a;
 return[0,1,2].map(function(k){return(242+(e[k]-242)*w)/255;});}
var faces=d.visits.map(function(f){
 var q=new Int16Array(bytes(f.places)),n=q.length,p=new Float32Array(n),m=new Float32Array(n);
 for(var i=0;i<n;i++)p[i]=q[i]/100;
 for(i=0;i<tri.length;i+=3){var a=3*tri[i],b=3*tri[i+1],c=3*tri[i+2];
  var ux=p[b]-p[a],uy=p[b+1]-p[a+1],uz=p[b+2]-p[a+2],vx=p[c]-p[a],vy=p[c+1]-p[a+1],vz=p[c+2]-p[a+2];
  var x=uy*vz-uz*vy,y=uz*vx-ux*vz,z=ux*vy-uy*vx;
  [a,b,c].forEach(function(j){m[j]+=x;m[j+1]+=y;m[j+2]+=z;});}
 var plain=new Float32Array(n),shown=new Float32Array(n),ch=f.change?new Int16Array(bytes(f.change)):null;
 for(i=0;i<n;i+=3){plain[i]=0.82;plain[i+1]=0.79;plain[i+2]=0.76;
  var col=ch?colour(ch[i/3],d.range):[0.82,0.79,0.76];for(var k=0;k<3;k++)shown[i+k]=col[k];}
 return{p:buffer(gl.ARRAY_BUFFER,p),n:buffer(gl.ARRAY_BUFFER,m),plain:buffer(gl.ARRAY_BUFFER,plain),
  shown:buffer(gl.ARRAY_BUFFER,shown),ink:buffer(gl.ARRAY_BUFFER,new Float32Array(n))};});
var yaw=0.4,pitch=0.1,zoom=1,which=faces.length-1,change=true,pending=false;
function bind(name,b){var i=gl.getAttribLocation(prog,name);if(i<0)return;gl.bindBuffer(gl.ARRAY_BUFFER,b);gl.enableVertexAttribArray(i);gl.vertexAttribPointer(i,3,gl.FLOAT,false,0,0);}
function draw(){pending=false;
 var size=Math.max(1,Math.round(canvas.clientWidth*(window.devicePixelRatio||1)));
 if(canvas.width!==size){canvas.width=size;canvas.height=size;}
 gl.viewport(0,0,size,size);gl.clear(gl.COLOR_BUFFER_BIT|gl.DEPTH_BUFFER_BIT);
 var cy=Math.cos(yaw),sy=Math.sin(yaw),cp=Math.cos(pitch),sp=Math.sin(pitch);
 gl.uniformMatrix3fv(at("r"),false,[cy,sp*sy,-cp*sy,0,cp,sp,sy,-sp*cy,cp*cy]);
 gl.uniform3fv(at("o"),[0,0,0]);gl.uniform1f(at("z"),zoom*1.9/d.size);
 var f=faces[which];bind("p",f.p);bind("n",f.n);bind("c",change?f.shown:f.plain);
 gl.uniform1f(at("flat_"),0);gl.uniform1f(at("lift"),0);
 gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER,triAt);gl.drawElements(gl.TRIANGLES,tri.length,gl.UNSIGNED_INT,0);
 if(rim.length){bind("c",f.ink);gl.uniform1f(at("flat_"),1);gl.uniform1f(at("lift"),0.004);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER,rimAt);gl.drawElements(gl.LINES,rim.length,gl.UNSIGNED_INT,0);}}
function again(){if(!pending){pending=true;requestAnimationFrame(draw);}}
function turn(x,y){yaw+=x;pitch=Math.max(-1.5,Math.min(1.5,pitch+y));again();}
function near(by){zoom=Math.max(0.5,Math.min(8,zoom*by));again();}
var held={},apart=0;
canvas.addEventListener("pointerdown",function(e){canvas.setPointerCapture(e.pointerId);held[e.pointerId]=[e.clientX,e.clientY];apart=0;});
canvas.addEventListener("pointermove",function(e){var h=held[e.pointerId];if(!h)return;
 var ids=Object.keys(held);if(ids.length===1)turn((e.clientX-h[0])*0.01,(e.clientY-h[1])*0.01);
 held[e.pointerId]=[e.clientX,e.clientY];
 if(ids.length===2){var a=held[ids[0]],b=held[ids[1]],l=Math.hypot(a[0]-b[0],a[1]-b[1]);if(apart)near(l/apart);apart=l;}});
["pointerup","pointercancel"].forEach(function(n){canvas.addEventListener(n,function(e){delete held[e.pointerId];apart=0;});});
canvas.addEventListener("wheel",function(e){e.preventDefault();near(Math.exp(-e.deltaY*0.001));},{passive:false});
canvas.addEventListener("keydown",function(e){var k={ArrowLeft:[-0.1,0],ArrowRight:[0.1,0],ArrowUp:[0,-0.1],ArrowDown:[0,0.1]}[e.key];
 if(k){e.preventDefault();turn(k[0],k[1]);}else if(e.key==="+")near(1.1);else if(e.key==="-")near(1/1.1);});
function press(group,pressed){root.querySelectorAll(group).forEach(function(b){b.setAttribute("aria-pressed",b===pressed?"true":"false");});again();}
root.querySelectorAll(".visit").forEach(function(b,i){b.onclick=function(){which=i;press(".visit",b);};});
root.querySelectorAll(".shade").forEach(function(b,i){b.onclick=function(){change=i===0;press(".shade",b);};});
window.addEventListener("resize",again);draw();
})();
)";

std::string button(const char* group, const std::string& text, bool pressed) {
    return std::string("<button type=\"button\" class=\"") + group + "\" aria-pressed=\"" +
           (pressed ? "true" : "false") + "\">" + html_text(text) + "</button>";
}

/// Places from `centre`, three 16-bit numbers each.
std::string places_of(const std::vector<Position>& positions, const Position& centre) {
    std::vector<std::int16_t> places;
    places.reserve(3 * positions.size());
    for (const Position& p : positions)
        for (std::size_t k = 0; k < 3; ++k) places.push_back(rounded(p[k] - centre[k]));
    return packed(places);
}

std::string packed_change(const std::vector<double>& change) {
    std::vector<std::int16_t> values;
    values.reserve(change.size());
    for (const double mm : change) values.push_back(std::isfinite(mm) ? rounded(mm) : kUnknown);
    return packed(values);
}

}  // namespace

std::string ReportPictures::view(const Words& words, const std::vector<std::string>& names) const {
    const MeshArrays& first = aligned_.front();
    const std::size_t each = 8 * first.positions.size(), fixed = 12 * first.triangles.size();
    const std::size_t room = fixed + 2 * each > kBudget ? 2 : (kBudget - fixed) / each;
    std::vector<std::size_t> held{0};
    const std::size_t count = aligned_.size();
    for (std::size_t k = count > room ? count - room + 1 : 1; k < count; ++k) held.push_back(k);

    Position least = first.positions.front(), most = least, centre{};
    for (const Position& p : first.positions)
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    double size = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        centre[k] = 0.5 * (least[k] + most[k]);
        size = std::max(size, most[k] - least[k]);
    }
    std::string data = "{\"size\":" + std::to_string(size) +
                       ",\"range\":" + std::to_string(range_mm_) +
                       ",\"triangles\":" + packed(first.triangles) + ",\"rims\":" + packed(rims_) +
                       ",\"visits\":[";
    std::string buttons;
    for (const std::size_t k : held) {
        data += std::string(k == 0 ? "" : ",") +
                "{\"places\":" + places_of(aligned_[k].positions, centre);
        if (k > 0) data += ",\"change\":" + packed_change(changes_[k]);
        data += "}";
        buttons += button("visit", names[k], k == held.back());
    }
    std::string html = "<p>" + words("turn_text");
    if (held.size() < count) html += " " + words("turn_some", {std::to_string(held.size() - 1)});
    return html + "</p><canvas tabindex=\"0\" role=\"img\" aria-label=\"" + words("turn_label") +
           "\"></canvas><p class=\"none\" hidden>" + words("turn_none") +
           "</p><div class=\"controls\">" + buttons + "<br>" +
           button("shade", words("show_change"), true) +
           button("shade", words("show_face"), false) +
           "</div><script type=\"application/json\" id=\"faces\">" + data + "]}</script><script>" +
           kScript + "</script>";
}

}  // namespace mien::cli
